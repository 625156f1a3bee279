// How do I ask when moving bodies meet? One function for each of the questions.
#pragma once

namespace how_do_i {

void cast_on_its_way();
void contact_with_a_normal();
void ball_on_a_floor();
void slide_and_enter();
void stop_at_a_distance();
void cast_a_cloth();
void cast_a_cloth_in_a_world();
void way_through_a_world();
void turn_past_a_post();
void turn_all_the_way();
void move_at_once();

}  // namespace how_do_i
