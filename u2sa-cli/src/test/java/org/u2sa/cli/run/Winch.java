package org.u2sa.cli.run;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.EventDrivenService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;

/** Says in a file beside its log each time that it is released. */
public final class Winch extends EventDrivenService {
  /** Name of the file. */
  static final String RELEASED = "released";

  private final Path file;

  public Winch(ServiceContext context) {
    super(context, ServiceRole.ACTUATOR, "Winch");
    file = context.logDirectory().resolve(RELEASED);
  }

  @Override
  public void callback(U2SAData data) {
    unexpected(data);
  }

  @Override
  protected void release() {
    try {
      Files.writeString(file, "released\n", StandardOpenOption.CREATE, StandardOpenOption.APPEND);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
