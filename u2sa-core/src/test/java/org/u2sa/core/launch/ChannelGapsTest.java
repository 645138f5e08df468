package org.u2sa.core.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.LockstepClock;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.EventDrivenService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;

class ChannelGapsTest {
  @TempDir private Path directory;
  private final List<String> console = new ArrayList<>();

  /** A service of a role that only registers. */
  private abstract static class Registering extends EventDrivenService {
    Registering(ServiceContext context, ServiceRole role, String name) {
      super(context, role, name);
    }

    @Override
    public void callback(U2SAData data) {
      unexpected(data);
    }
  }

  /** Waits for states and points; commands. */
  public static final class Controller extends Registering {
    public Controller(ServiceContext context) {
      super(context, ServiceRole.CONTROL_SYSTEM, "Control");
      registerSubscriber(Channels.STATE);
      registerSubscriber(Channels.NAVIGATION);
      registerPublisher(Channels.ACTUATION);
    }
  }

  /** Fills every gap of the controller's. */
  public static final class Rest extends Registering {
    public Rest(ServiceContext context) {
      super(context, ServiceRole.ACTUATOR, "Rest");
      registerPublisher(Channels.STATE);
      registerPublisher(Channels.NAVIGATION);
      registerSubscriber(Channels.ACTUATION);
    }
  }

  /** Watches everything, and drives nothing. */
  public static final class Watcher extends Registering {
    public Watcher(ServiceContext context) {
      super(context, ServiceRole.OBSERVER, "Watcher");
      registerSubscriber(Channels.STATE);
      registerSubscriber(Channels.ACTUATION);
    }
  }

  private Path start(LaunchOptions options, Class<?>... services) throws IOException {
    StringBuilder text = new StringBuilder("<system id=\"test\">");
    for (Class<?> each : services) {
      text.append("<service class=\"" + each.getName() + "\"/>");
    }
    Path file = Files.writeString(directory.resolve("system.xml"), text + "</system>");
    options
        .clock(new LockstepClock())
        .console(console::add)
        .logDirectory(directory.resolve("logs"))
        .override("CommunicationManager", "BROKER", "none");
    RunningSystem.start(SystemFile.read(file), options).close();
    return file;
  }

  @Test
  void start_controlAlone_tellsWhatIsMissing() throws IOException {
    Path file = start(new LaunchOptions(), Controller.class, Watcher.class);

    assertThat(console)
        .containsExactly(
            file + ": no service publishes \"state\"; needed by Control",
            file + ": no service publishes \"navigation\"; needed by Control",
            file + ": no service drives actuators by \"actuation\"; needed by Control");
  }

  @Test
  void start_completeOrWithoutControlOrOneOfSeveral_tellsNothing() throws IOException {
    start(new LaunchOptions(), Controller.class, Rest.class);
    start(new LaunchOptions(), Watcher.class);
    start(new LaunchOptions().oneOfSeveral(false), Controller.class);

    assertThat(console).isEmpty();
  }
}
