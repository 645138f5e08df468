package org.u2sa.cli.run;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.cli.command.BaseCommand;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.remote.RemoteSystem;
import org.u2sa.gcs.mavlink.BridgeOptions;
import org.u2sa.gcs.mavlink.MavlinkBridge;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.interfaces.communication.CommunicationException;
import org.u2sa.interfaces.time.Clock;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** {@code u2sa mavlink}: bridges a running system to MAVLink ground stations. */
@Command(
    name = "mavlink",
    description = {
      "Let MAVLink ground stations operate a running system.",
      "",
      "  ./u2sa mavlink tcp:5760                          stations connect here",
      "  ./u2sa mavlink udp:127.0.0.1:14550,as=ardupilot  a station listens there",
      "  ./u2sa mavlink serial:/dev/ttyUSB0,baud=57600    a station is behind a telemetry radio",
      "",
      "Stations have the rights of the user as whom this command joins the broker: an "
          + "observer's allow them to see but not to command. Options after the link: as, type, id, key, logs and baud "
          + "(docs/mavlink.md)."
    })
public final class MavlinkCommand extends BaseCommand {
  private static final double TIME_EVERY_S = 30.0;

  @Mixin private RemoteSystem remote;

  @Parameters(
      arity = "1..*",
      paramLabel = "LINK",
      description = "tcp:PORT, udp:HOST:PORT or serial:PATH.")
  private List<String> links;

  @Override
  public Integer call() throws InterruptedException {
    List<BridgeOptions> parsed = new ArrayList<>();
    for (String link : links) {
      try {
        parsed.add(BridgeOptions.parse(link));
      } catch (IllegalArgumentException e) {
        throw wrong(e.getMessage());
      }
    }
    List<MavlinkBridge> bridges = new ArrayList<>();
    List<RemoteLink> joined = new ArrayList<>();
    Thread time = new Thread(() -> keepTime(joined), "u2sa-mavlink-time");
    time.setDaemon(true);
    try {
      for (BridgeOptions each : parsed) {
        RemoteLink link = remote.connectForOrders();
        joined.add(link);
        bridges.add(new MavlinkBridge(link, each, this::tell));
        print("MAVLink ground stations: " + each + ". Ctrl-C ends it.");
      }
      out().flush();
      time.start();
      for (MavlinkBridge bridge : bridges) {
        bridge.await();
      }
    } finally {
      time.interrupt();
      bridges.forEach(MavlinkBridge::close);
    }
    return ExitCode.FAILED; // a bridge ends on its own only when its link fails
  }

  /** The vehicle may be restarted with another clock while the bridge goes on. */
  private void keepTime(List<RemoteLink> joined) {
    Clock clock = joined.get(0).clock();
    try (Clock.Waiter waiter = clock.newWaiter("mavlink-time")) {
      while (!Thread.currentThread().isInterrupted()) {
        long due = clock.micros() + Clock.micros(TIME_EVERY_S);
        while (clock.micros() < due) {
          waiter.await(due);
        }
        for (RemoteLink link : joined) {
          keepTime(link);
        }
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private void keepTime(RemoteLink link) throws InterruptedException {
    try {
      link.adoptTime();
    } catch (CommunicationException e) {
      tell("cannot ask for the vehicle's time now: " + e.getMessage());
    }
  }
}
