-- Where a robot's arm picks a task's load up, and where it puts it down, metres, map frame. Null: no arm does.
alter table tasks add column arm_pick_x double;
alter table tasks add column arm_pick_y double;
alter table tasks add column arm_place_x double;
alter table tasks add column arm_place_y double;
