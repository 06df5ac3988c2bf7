alter table users modify column role enum('CLERK', 'MANAGER', 'ADMINISTRATOR') not null;

-- Who could manage everything still can: the manager who was first.
update users set role = 'ADMINISTRATOR'
where id = (
  select first_id from (
    select min(id) as first_id from users where role = 'MANAGER' and not disabled
  ) as managers
);

-- Sites that share this server; the first one's database has them all. Each other one has a database
-- of its own, by the id, which no other site gets. A name is unique without regard to case, by its
-- lower-cased key. One that is not complete is being made.
create table sites (
  id bigint auto_increment primary key,
  name_key varchar(32) not null,
  name varchar(32) not null,
  complete boolean not null,
  constraint sites_name_key unique (name_key)
);
insert into sites (id, name_key, name, complete) values (1, 'main', 'main', true);
