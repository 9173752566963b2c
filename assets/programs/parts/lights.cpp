std::vector<Light> sources;  // in camera coordinates, colours times intensity
//@if first_light
Light first_light;  // its kind and position
//@end

/// Topic: light sources. World lights go through the view matrix; camera lights stay with the viewer.
void place_lights(const mat4& view) {
    for (const Light& light : lights) {
        Light s = light;
        //@if wrong.last_light_only
        sources.clear();
        //@end
        //@if wrong.light_in_wrong_space
        @const_frame@mat4 to_camera = light.space == camera ? view : identity;
        //@else
        //@if wrong.light_by_inverse_view
        (void)view;
        @const_frame@mat4 to_camera = light.space == world ? world_from_view() : identity;
        //@else
        @const_frame@mat4 to_camera = light.space == world ? view : identity;
        //@end
        //@end
        //@if wrong.light_moved_twice
        to_camera = view * to_camera;
        //@end
        //@if wrong.average_of_lights
        s.intensity /= double(lights.size());
        //@end
        for (vec3* color : {&s.ambient, &s.diffuse, &s.specular}) *color = s.intensity * *color;
        s.position = moved(to_camera, light.position, light.kind == directional ? 0 : 1);
        //@if wrong.direction_is_position
        if (light.kind == directional) {
            s.kind = point;
            s.position = moved(to_camera, light.position, 1);
        }
        //@end
        //@if light.directional
        //@if wrong.unnormalized_light
        // (the direction is not normalized)
        //@else
        if (s.kind == directional) s.position = unit(s.position);
        //@end
        //@if wrong.light_direction_reversed
        if (s.kind == directional) s.position = -1 * s.position;
        //@end
        //@end
        //@if light.falloff
        //@if wrong.falloff_of_directional
        if (s.kind == directional) {
            const double r = length(light.position);
            s.constant = light.constant + r * (light.linear + r * light.quadratic);
            s.linear = s.quadratic = 0;
        }
        //@end
        //@if wrong.falloff_without_constant
        if (light.kind == point || light.kind == spot) s.constant = 0;
        //@end
        //@if wrong.falloff_forgotten
        s.constant = 1;
        s.linear = s.quadratic = 0;
        //@end
        //@end
        //@if light.spot
        //@if wrong.aim_stays_at_origin
        const vec3 origin = light.space == world ? vec3{} : moved(view, {}, 1);
        s.direction = unit(moved(to_camera, origin - light.position, 0));
        //@else
        s.direction = unit(moved(to_camera, light.direction, 0));
        //@end
        //@end
        //@if first_light
        if (sources.empty()) first_light = s;
        //@end
        //@if light.area
        s.edge_u = moved(to_camera, light.edge_u, 0);
        s.edge_v = moved(to_camera, light.edge_v, 0);
        //@if !shader
        // Topic: area lights: many points, each a separate light.
        const vec3 centre = s.position;
        for (int i = 0; light.kind == area && i < light.cells * light.cells; ++i) {
            const double a = (2.0 * (i / light.cells) + 1) / light.cells - 1;
            const double b = (2.0 * (i % light.cells) + 1) / light.cells - 1;
            s.position = centre + a * s.edge_u + b * s.edge_v;
            sources.push_back(s);
        }
        if (light.kind == area) continue;
        //@end
        //@end
        sources.push_back(s);
    }
}

