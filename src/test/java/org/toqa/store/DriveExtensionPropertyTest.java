package org.toqa.store;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Optional;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.lifecycle.AfterProperty;
import net.jqwik.api.lifecycle.BeforeProperty;
import org.toqa.fleet.FleetStore.DriveExtension;
import org.toqa.fleet.FleetStore.StoredDrive;

/** Whatever a drive is extended by, a server that starts then finds it so. */
class DriveExtensionPropertyTest {
  private final Database database = MemoryDatabase.open("extensions-" + System.nanoTime());
  private final JdbiFleetStore store = new JdbiFleetStore(database.jdbi());

  @BeforeProperty
  void addRobots() {
    store.saveRobot(FleetDatabaseTest.R1);
    store.saveRobot(FleetDatabaseTest.R2);
  }

  @AfterProperty
  void close() {
    database.close();
  }

  @Property(tries = 40)
  void anyExtensionsComeBack(
      @ForAll @IntRange(min = 1, max = 1_000_000) int seq,
      @ForAll @IntRange(max = 12) int extensions) {
    StoredDrive other = ScriptedDrives.begun("r2", seq);
    store.saveDrive("r2", other);
    StoredDrive drive = ScriptedDrives.begun("r1", seq);
    store.saveDrive("r1", drive);
    for (int i = 0; i < extensions; i++) {
      DriveExtension extension = ScriptedDrives.extension("r1", drive);
      store.saveExtension("r1", extension);
      drive = drive.with(extension);
    }
    assertEquals(Optional.of(drive), store.drive("r1"));
    assertEquals(Optional.of(other), store.drive("r2"));
  }
}
