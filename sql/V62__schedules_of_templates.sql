-- sql/V62__schedules_of_templates.sql
-- The template that a schedule's order was made from, and the values of its parameters as JSON; null: from none.
alter table schedules add column template_id bigint;
alter table schedules add column template_values text;
alter table schedules add constraint schedules_template foreign key (template_id) references task_templates (id);
