-- Devices of the network: robots, cameras and access points, and what managers said of their addresses. Where both are known
-- the DHCP server keeps the address for the device.
create table network_devices (
  id bigint not null auto_increment primary key,
  name varchar(64) not null,
  kind varchar(16) not null, -- robot, camera, access-point or other
  hardware_address char(17), -- six bytes, lower case
  address varchar(15), -- IPv4
  constraint network_devices_name unique (name),
  constraint network_devices_hardware unique (hardware_address),
  constraint network_devices_address unique (address)
);
