package org.toqa.sim;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;

/**
 * The firmware's hex file in a simulated ATmega128 with its motors and sensors: the program {@code
 * toqa-sim} of {@code firmware/}, in a process of its own.
 */
public final class SimulatedMicrocontroller implements AutoCloseable {

  private static final String PROGRAM = "toqa-sim";
  private static final String SOCKET = "spi.sock";
  private static final String EEPROM = "eeprom";
  private static final long CLOSE_TIMEOUT_SECONDS = 2;

  private final Process process;
  private final Path socket;

  /**
   * Which chip it is, and what drives its motors.
   *
   * @param hex its program, in the folder of the built firmware
   * @param drive the drive's name, as {@code toqa-sim} knows it
   * @param hertz the frequency of its clock
   */
  public record Board(String hex, String drive, int hertz) {

    /** The robot's own: three LM629, and an ATmega128. */
    public static final Board LM629 = new Board("toqa.hex", "lm629", 16_000_000);
  }

  private SimulatedMicrocontroller(Process process, Path socket) {
    this.process = process;
    this.socket = socket;
  }

  /**
   * @param firmware the folder of the built firmware
   * @param folder where its socket is made, and its EEPROM is kept: one that is found there was
   *     switched off, and is switched on again
   * @throws IOException when the firmware is not built or the simulator does not start
   */
  public static SimulatedMicrocontroller start(Path firmware, Path folder) throws IOException {
    return start(firmware, Board.LM629, folder);
  }

  /**
   * The same with another board.
   *
   * @throws IOException as above
   */
  public static SimulatedMicrocontroller start(Path firmware, Board board, Path folder)
      throws IOException {
    Path program = firmware.resolve(PROGRAM);
    Path hex = firmware.resolve(board.hex());
    if (!Files.isExecutable(program) || !Files.isReadable(hex)) {
      throw new IOException(
          "The firmware is not built in " + firmware + ": run make -C firmware hex sim.");
    }
    Process process =
        new ProcessBuilder(
                program.toString(),
                "-c",
                Integer.toString(board.hertz()),
                "-d",
                board.drive(),
                hex.toString(),
                folder.resolve(SOCKET).toString(),
                folder.resolve(EEPROM).toString())
            .redirectError(ProcessBuilder.Redirect.INHERIT)
            .start();
    SimulatedMicrocontroller started =
        new SimulatedMicrocontroller(process, folder.resolve(SOCKET));
    started.awaitListening();
    return started;
  }

  public Path socket() {
    return socket;
  }

  @Override
  public void close() {
    process.destroy();
    try {
      if (!process.waitFor(CLOSE_TIMEOUT_SECONDS, TimeUnit.SECONDS)) {
        process.destroyForcibly();
      }
    } catch (InterruptedException e) {
      process.destroyForcibly();
      Thread.currentThread().interrupt();
    }
  }

  /** Its only line says that it listens; it ends without one when it cannot. */
  private void awaitListening() throws IOException {
    BufferedReader output = process.inputReader();
    if (output.readLine() == null) {
      close();
      throw new IOException("The simulated microcontroller does not start.");
    }
  }
}
