-- Room beside the way of a robot's last drive that is its own, to drive round something; null: none.
alter table drives add column room_from int;
alter table drives add column room_to int;
alter table drives add column room_left double precision;
alter table drives add column room_right double precision;
