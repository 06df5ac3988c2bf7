package org.toqa.app.gateway;

import java.nio.file.Path;
import java.util.concurrent.Callable;
import org.toqa.app.command.StopSignal;
import org.toqa.link.gateway.GatewayAgent;
import org.toqa.link.trust.IdentityFile;
import org.toqa.link.trust.LinkTls;
import org.toqa.link.trust.PrivateFolder;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** {@code toqa gateway}: until it is told to end. */
@Command(
    name = "gateway",
    description = "Carry the links of a site's robots to a server elsewhere, until Ctrl-C.",
    footer = {"", "docs/gateway.md explains the file."})
public final class GatewayCommand implements Callable<Integer> {

  @Option(
      names = "--config",
      paramLabel = "FILE",
      required = true,
      description = "Read the configuration from a YAML file.")
  private Path config = Path.of("");

  @Override
  public Integer call() throws Exception {
    GatewayConfiguration configuration = GatewayConfiguration.read(config);
    PrivateFolder.create(configuration.data());
    LinkTls tls = new LinkTls(IdentityFile.open(configuration.data()));
    System.err.println("The fingerprint of this gateway is " + tls.fingerprint());
    try (StopSignal stop = new StopSignal();
        GatewayAgent _ = new GatewayAgent(configuration.server(), configuration.robots(), tls)) {
      stop.await();
      return 0;
    }
  }
}
