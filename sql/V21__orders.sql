-- Orders that are carried as several tasks: pieces, or the legs from stop to stop. An order goes with the last of its tasks.
create table orders (
  id bigint not null auto_increment primary key,
  name varchar(100) not null,
  kind enum('PIECES', 'STOPS') not null,
  parts int not null, -- how many were ordered
  created_at datetime(3) not null
);

alter table tasks add column order_id bigint;
alter table tasks add column order_part int; -- from 1; the newest task of a part counts
alter table tasks add column awaits_previous boolean not null default false; -- begins when the part before it is delivered
alter table tasks add constraint tasks_order foreign key (order_id) references orders (id);
