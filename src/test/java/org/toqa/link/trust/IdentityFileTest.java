package org.toqa.link.trust;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class IdentityFileTest {

  @TempDir private Path folder;

  @Test
  void restartKeepsTheKey() throws IOException {
    Fingerprint first = IdentityFile.open(folder).fingerprint();

    assertEquals(first, IdentityFile.open(folder).fingerprint());
  }

  @Test
  void everyFolderHasAKeyOfItsOwn() throws IOException {
    Path other = Files.createDirectory(folder.resolve("other"));

    assertNotEquals(
        IdentityFile.open(folder).fingerprint(), IdentityFile.open(other).fingerprint());
  }

  @Test
  void onlyTheOwnerMayReadTheKey() throws IOException {
    IdentityFile.open(folder);

    assertEquals(
        "rw-------",
        PosixFilePermissions.toString(Files.getPosixFilePermissions(folder.resolve("link.p12"))));
  }

  @Test
  void keyThatOthersMayReadStopsTheStart() throws IOException {
    IdentityFile.open(folder);
    Files.setPosixFilePermissions(
        folder.resolve("link.p12"), PosixFilePermissions.fromString("rw-r-----"));

    IOException e = assertThrows(IOException.class, () -> IdentityFile.open(folder));
    assertBegins(e, "Others than its owner may read");
  }

  @Test
  void brokenKeyStopsTheStartAndIsNotReplaced() throws IOException {
    new PrivateFile(folder.resolve("link.p12")).write(new byte[] {1, 2, 3});

    IOException e = assertThrows(IOException.class, () -> IdentityFile.open(folder));
    assertBegins(e, "The key in ");
    assertEquals(3, Files.size(folder.resolve("link.p12")));
  }

  private static void assertBegins(IOException e, String beginning) {
    String sentence = String.valueOf(e.getMessage());
    assertTrue(sentence.startsWith(beginning), sentence);
  }
}
