-- Where programs are told. The secret is in clear, since the server signs by it. kinds: their words, with commas between.
create table webhooks (
  id bigint not null auto_increment primary key,
  url varchar(500) not null,
  secret varchar(100) not null,
  kinds varchar(1000) not null,
  enabled boolean not null,
  created_at datetime(3) not null,
  created_by varchar(64) not null
);

-- What is to be told to whom: a letter to a user, or a request to a webhook. It is written together with its notice.
create table notice_deliveries (
  id bigint not null auto_increment primary key,
  uid char(36) not null,
  notice_id bigint not null,
  user_id bigint,
  webhook_id bigint,
  ending boolean not null,
  state enum('WAITING', 'SENT', 'GIVEN_UP') not null,
  attempts int not null,
  created_at datetime(3) not null,
  next_at datetime(3) not null,
  done_at datetime(3),
  failure varchar(300),
  constraint notice_deliveries_uid unique (uid),
  constraint notice_deliveries_notice foreign key (notice_id) references notices (id) on delete cascade,
  constraint notice_deliveries_user foreign key (user_id) references users (id) on delete cascade,
  constraint notice_deliveries_webhook foreign key (webhook_id) references webhooks (id) on delete cascade,
  key notice_deliveries_due (state, next_at)
);
