package org.toqa.link.trust;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyStore;
import java.security.cert.Certificate;
import java.util.Optional;

/** The file {@code link.p12} in an end's data folder: its identity, made at its first start. */
public final class IdentityFile {

  private static final String NAME = "link.p12";

  /** PKCS #12 wants one. What keeps the key secret are the file's rights. */
  private static final char[] PASSWORD = "toqa".toCharArray();

  private IdentityFile() {}

  /**
   * Reads the identity, or makes a new one.
   *
   * @throws IOException with a sentence for people
   */
  public static Identity open(Path folder) throws IOException {
    PrivateFile file = new PrivateFile(folder.resolve(NAME));
    Optional<byte[]> content = file.read();
    if (content.isPresent()) {
      return read(file, content.get());
    }
    return create(file);
  }

  private static Identity read(PrivateFile file, byte[] content) throws IOException {
    try {
      KeyStore keys = KeyStore.getInstance("PKCS12");
      keys.load(new ByteArrayInputStream(content), PASSWORD);
      return new Identity(keys, PASSWORD);
    } catch (IOException | GeneralSecurityException e) {
      throw new IOException(
          "The key in %s cannot be read (%s); put back a copy of the file, or remove it and pair anew."
              .formatted(file, e.getMessage()),
          e);
    }
  }

  private static Identity create(PrivateFile file) throws IOException {
    try {
      SelfSignedCertificate made = SelfSignedCertificate.generate();
      KeyStore keys = KeyStore.getInstance("PKCS12");
      keys.load(null, PASSWORD);
      keys.setKeyEntry(
          Identity.ALIAS,
          made.keys().getPrivate(),
          PASSWORD,
          new Certificate[] {made.certificate()});
      ByteArrayOutputStream content = new ByteArrayOutputStream();
      keys.store(content, PASSWORD);
      file.write(content.toByteArray());
      return new Identity(keys, PASSWORD);
    } catch (GeneralSecurityException e) {
      throw new IOException("No key for the link could be made: " + e.getMessage(), e);
    }
  }
}
