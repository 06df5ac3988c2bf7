-- What was said, for readers of other languages: JSON, the phrase's name and its values. Null: there is only the English text.
alter table events add column said varchar(2000);
alter table tasks add column trouble_said varchar(2000);
