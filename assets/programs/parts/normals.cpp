        //@if wrong.normals_left_in_object
        const mat4& for_normals = identity;
        //@else
        //@if wrong.normals_left_in_world
        const vec3 scale = object.scale;
        const mat4 for_normals = transform({}, object.rotate_deg, {1 / scale.x, 1 / scale.y, 1 / scale.z});
        //@else
        //@if wrong.normals_by_model_matrix|wrong.normals_as_points
        const mat4& for_normals = to_camera;
        //@else
        // Topic: normals use the inverse transpose of M: rotated like points, but scaled the other way.
        const vec3 scale = object.scale;
        const mat4 for_normals =
            view * transform({}, object.rotate_deg, {1 / scale.x, 1 / scale.y, 1 / scale.z});
        //@end
        //@end
        //@end
