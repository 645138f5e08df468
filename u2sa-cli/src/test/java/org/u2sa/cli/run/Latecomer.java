package org.u2sa.cli.run;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardWatchEventKinds;
import java.nio.file.WatchService;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.EventDrivenService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;

/** A service that is not there before a file exists. */
public final class Latecomer extends EventDrivenService {
  static final String GATE = "LATECOMER_GATE"; // environment variable: the file

  public Latecomer(ServiceContext context) {
    super(wait(context), ServiceRole.ACTUATOR, "Latecomer");
  }

  private static ServiceContext wait(ServiceContext context) {
    Path gate = Path.of(System.getenv(GATE));
    try (WatchService watch = gate.getFileSystem().newWatchService()) {
      gate.getParent().register(watch, StandardWatchEventKinds.ENTRY_CREATE);
      while (!Files.exists(gate)) {
        watch.take().reset();
      }
      return context;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    } catch (InterruptedException e) {
      throw new IllegalStateException(e);
    }
  }

  @Override
  public void callback(U2SAData data) {
    unexpected(data);
  }
}
