-- The free zone through which a robot on its last drive finds its own way; null: none.
alter table drives add column zone_x double precision;
alter table drives add column zone_y double precision;
alter table drives add column zone_width double precision;
alter table drives add column zone_height double precision;
