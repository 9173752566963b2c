        //@if turned_normals
        double side = 1;  // -1: all normals are reversed
        //@end
        //@if normals.flip
        side = object.side;
        //@end
        //@if wrong.normals_flipped
        side = -side;
        //@end
        //@if wrong.mirror_turns_inside_out
        if (o.mirrored) side = -side;
        //@end
