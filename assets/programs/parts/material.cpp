        //@if reflection.lit
        o.material = object.material;
        //@end
        //@if wrong.lit_in_srgb
        for (vec3* c : {&o.material.ambient, &o.material.diffuse, &o.material.specular}) *c = srgb(*c);
        //@if terms.emission
        o.material.emission = srgb(o.material.emission);
        //@end
        //@end
        //@if wrong.coefficients_swapped
        std::swap(o.material.diffuse, o.material.specular);
        //@end
        //@if wrong.shininess_as_fraction&uses.shininess
        o.material.shininess /= 128;
        //@end
        //@if wrong.shininess_inverted&uses.shininess
        if (o.material.shininess > 0) o.material.shininess = 1 / o.material.shininess;
        //@end
        //@if shininess.capped
        o.material.shininess = std::min(o.material.shininess, 128.0);  // OpenGL's maximum
        //@end
