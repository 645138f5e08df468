package org.u2sa.cli.run;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.cli.command.BaseCommand;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.remote.RemoteSystem;
import org.u2sa.gcs.mavlink.BridgeOptions;
import org.u2sa.gcs.mavlink.MavlinkBridge;
import org.u2sa.gcs.mavlink.SigningKeys;
import org.u2sa.gcs.remote.RemoteLink;
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
    SigningKeys keys = new SigningKeys();
    try {
      for (BridgeOptions each : parsed) {
        RemoteLink link = remote.connect();
        link.keepTime();
        bridges.add(new MavlinkBridge(link, each, keys, this::tell));
        print("MAVLink ground stations: " + each + ". Ctrl-C ends it.");
      }
      out().flush();
      for (MavlinkBridge bridge : bridges) {
        bridge.await();
      }
    } finally {
      bridges.forEach(MavlinkBridge::close);
    }
    return ExitCode.FAILED; // a bridge ends on its own only when its link fails
  }
}
