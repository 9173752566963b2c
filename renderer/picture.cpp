#include "renderer/picture.h"
