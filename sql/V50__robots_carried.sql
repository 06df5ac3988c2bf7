-- Carried to another floor, and not located there since: what it says of its place is of the old one.
alter table robots add column carried boolean not null default false;
