package org.u2sa.core.health;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.core.launch.RunningSystem;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.testkit.FreePort;

/** The same with Communication Manager, victim and monitor apart, as in three processes. */
class RealCausesOverMqttTest extends RealCausesTest {
  private static final String MANAGER = "CommunicationManager";

  @Override
  List<RunningSystem> start(SystemFile file, Supplier<LaunchOptions> options) throws IOException {
    int port = FreePort.find();
    List<RunningSystem> parts = new ArrayList<>();
    parts.add(RunningSystem.start(file.withoutServices(), at(port, options.get())));
    for (SystemFile.Entry entry : file.services()) {
      parts.add(
          RunningSystem.start(
              file.only(List.of(entry.simpleName())),
              at(port, options.get()).override(MANAGER, "BROKER", "external").oneOfSeveral(false)));
    }
    return parts;
  }

  private static LaunchOptions at(int port, LaunchOptions options) {
    return options.override(MANAGER, "COMMUNICATION MANAGER PORT", port);
  }
}
