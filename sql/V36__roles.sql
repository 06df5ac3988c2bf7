-- Viewers look; operators keep the robots and everybody's tasks going.
alter table users modify column role
  enum('CLERK', 'MANAGER', 'ADMINISTRATOR', 'OPERATOR', 'VIEWER') not null;
