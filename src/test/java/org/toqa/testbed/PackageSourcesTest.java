package org.toqa.testbed;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** From where {@code ./toqa test} takes packages, by samples of what systems have in /etc. */
class PackageSourcesTest {
  private static final String DEBIAN = "ID=debian\nVERSION_CODENAME=bookworm\n";
  private static final String UBUNTU =
      "ID=ubuntu\nID_LIKE=debian\nVERSION_CODENAME=noble\nUBUNTU_CODENAME=noble\n";

  @TempDir private Path etc;

  @BeforeEach
  void makeFolders() throws IOException {
    Files.createDirectories(etc.resolve("apt/sources.list.d"));
  }

  @Test
  void debianAsItIsInstalledNow() throws Exception {
    write("os-release", DEBIAN);
    write(
        "apt/sources.list.d/debian.sources",
        """
        Types: deb
        URIs: http://security.example/debian-security
        Suites: bookworm-security
        Components: main

        Types: deb deb-src
        URIs: http://mirror.example/debian
        Suites: bookworm bookworm-updates
        Components: main contrib
        Signed-By: /usr/share/keyrings/debian-archive-keyring.gpg
        """);

    assertEquals("http://mirror.example/debian/", mirror());
  }

  @Test
  void debianInOneLineEach() throws Exception {
    write("os-release", DEBIAN);
    write(
        "apt/sources.list",
        """
        # deb cdrom:[Debian]/ bookworm main
        deb [arch=amd64] https://others.example/linux/debian bookworm stable
        deb-src http://src.example/debian/ bookworm main
        deb http://mirror.example/debian/ bookworm main contrib non-free-firmware
        """);

    assertEquals("http://mirror.example/debian/", mirror());
  }

  @Test
  void ubuntuAsItIsInstalledNow() throws Exception {
    write("os-release", UBUNTU);
    write(
        "apt/sources.list.d/a-ppa.sources",
        """
        Types: deb
        URIs: https://others.example/somebody/tools/ubuntu/
        Suites: noble
        Components: main
        """);
    write(
        "apt/sources.list.d/ubuntu.sources",
        """
        Types: deb
        URIs: http://mirror.example/ubuntu/
        Suites: noble noble-updates noble-backports
        Components: main restricted universe multiverse
        Signed-By: /usr/share/keyrings/ubuntu-archive-keyring.gpg

        Types: deb
        URIs: http://security.example/ubuntu/
        Suites: noble-security
        Components: main restricted universe multiverse
        """);

    assertEquals("http://mirror.example/ubuntu/", mirror());
  }

  @Test
  void ubuntuOfAnotherProcessorInOneLineEach() throws Exception {
    write("os-release", UBUNTU.replace("noble", "jammy"));
    write(
        "apt/sources.list",
        """
        deb http://mirror.example/ubuntu-ports/ jammy-security main universe
        deb http://mirror.example/ubuntu-ports/ jammy main restricted
        deb http://mirror.example/ubuntu-ports jammy universe
        """);

    assertEquals("http://mirror.example/ubuntu-ports/", mirror());
  }

  @Test
  void systemMadeOfUbuntu() throws Exception {
    write(
        "os-release",
        "ID=linuxmint\nID_LIKE=\"ubuntu debian\"\nVERSION_CODENAME=wilma\nUBUNTU_CODENAME=noble\n");
    write(
        "apt/sources.list.d/official.list",
        """
        deb http://others.example wilma main upstream import backport
        deb http://mirror.example/ubuntu noble main restricted universe multiverse
        """);

    assertEquals("http://mirror.example/ubuntu/", mirror());
  }

  @Test
  void machineWithoutSourcesIsToldSo() throws Exception {
    write("os-release", DEBIAN);

    Process script = run("say() { echo \"$1\"; }; . src/test/services/debian.sh; mirror");

    assertEquals(
        "found no package source of debian in %s/apt; add one and try again".formatted(etc),
        said(script));
    assertEquals(1, script.waitFor());
  }

  private void write(String file, String content) throws IOException {
    Files.writeString(etc.resolve(file), content);
  }

  private String mirror() throws Exception {
    Process script = run(". src/test/services/debian.sh; mirror");
    String said = said(script);
    assertEquals(0, script.waitFor());
    return said;
  }

  private Process run(String script) throws IOException {
    ProcessBuilder shell = new ProcessBuilder(List.of("sh", "-euc", script));
    shell.environment().put("TOQA_TEST_ETC", etc.toString());
    shell.redirectError(ProcessBuilder.Redirect.INHERIT);
    return shell.start();
  }

  private static String said(Process script) throws IOException {
    return new String(script.getInputStream().readAllBytes(), StandardCharsets.UTF_8).strip();
  }
}
