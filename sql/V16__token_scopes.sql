-- A login by the API is a short session; it was a token without a name. Scopes: what a token may do of what its user may; null: all of it.
alter table sessions modify column kind enum('BROWSER', 'TOKEN', 'API') not null;
update sessions set kind = 'API' where kind = 'TOKEN' and name is null;
alter table sessions add column scopes varchar(100);
update sessions set scopes = 'READ,TASKS,MANAGE,METRICS' where kind = 'TOKEN';

-- Links by which a forgotten password is replaced; a user may have several, of which none voids another.
create table reset_links (
  secret_hash char(64) not null primary key, -- SHA-256, hex
  user_id bigint not null,
  expires_at datetime(3) not null,
  constraint reset_links_user foreign key (user_id) references users (id) on delete cascade
);

insert into reset_links (secret_hash, user_id, expires_at) select secret_hash, user_id, expires_at from password_resets;

drop table password_resets;
