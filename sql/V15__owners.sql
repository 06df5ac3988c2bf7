-- Schedules belong to a user by his id, as tasks do: names come back, ids do not. Null: he is no user any more.
alter table schedules add column user_id bigint;
update schedules set user_id =
  (select u.id from users u where u.name_key = lower(schedules.user_name) and u.created_at <= schedules.created_at);
alter table schedules add constraint schedules_user foreign key (user_id) references users (id) on delete set null;
