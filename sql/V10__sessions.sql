-- Logins that last: of a browser, which shows its secret in a cookie, or of a program, which shows it as a bearer token.
create table sessions (
  id bigint not null auto_increment primary key,
  user_id bigint not null,
  kind enum('BROWSER', 'TOKEN') not null,
  name varchar(64), -- of a token that its owner made by hand
  secret_hash char(64) not null, -- SHA-256, hex
  address varchar(64) not null, -- where it began
  agent varchar(200) not null, -- what began it, as it calls itself
  created_at datetime(3) not null,
  seen_at datetime(3) not null, -- within a minute
  expires_at datetime(3) not null,
  constraint sessions_secret_hash unique (secret_hash),
  constraint sessions_user foreign key (user_id) references users (id) on delete cascade,
  key sessions_expires_at (expires_at)
);

insert into sessions (user_id, kind, secret_hash, address, agent, created_at, seen_at, expires_at)
  select user_id, 'TOKEN', token_hash, '', '', created_at, created_at, expires_at from api_tokens;

drop table api_tokens;

alter table users add column email varchar(254);

-- Links by which a forgotten password is replaced; each user has at most one.
create table password_resets (
  user_id bigint not null primary key,
  secret_hash char(64) not null, -- SHA-256, hex
  expires_at datetime(3) not null,
  constraint password_resets_secret_hash unique (secret_hash),
  constraint password_resets_user foreign key (user_id) references users (id) on delete cascade
);
