package org.toqa.store;

import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.toqa.persistence.StoreException;
import org.toqa.testbed.FaultyTcpProxy;
import org.toqa.testbed.RealMySql;

/** A MySQL server whose machine is unplugged: connections stay, and no answer comes. */
@Tag("full")
class SilentDatabaseTest {

  @Test
  void isGivenUpByAConnectionThatWasAnsweredAMomentAgo() throws Exception {
    String url = RealMySql.newDatabase();
    try (FaultyTcpProxy cable = FaultyTcpProxy.toDatabase(url);
        Database database = Database.open(cable.through(url), "", "")) {
      JdbiFleetStore store = new JdbiFleetStore(database.jdbi());
      store.checkAvailable(); // the pool trusts a connection for half a second after this
      cable.silence();
      CompletableFuture<Void> check = CompletableFuture.runAsync(store::checkAvailable);
      ExecutionException given =
          assertThrows(ExecutionException.class, () -> check.get(1, TimeUnit.MINUTES));
      assertInstanceOf(StoreException.class, given.getCause());
      cable.cut(); // what still waits for an answer is told that none comes
    }
  }
}
