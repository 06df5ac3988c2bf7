-- When the load was expected to be delivered: just after it was ordered, and when robots had just got it.
alter table tasks add column expected_at_order datetime(3);
alter table tasks add column expected_at_start datetime(3);
create index tasks_expected on tasks (delivered_at, created_at, expected_at_order, expected_at_start);
alter table tasks drop index tasks_delivered; -- the one before begins as it did
