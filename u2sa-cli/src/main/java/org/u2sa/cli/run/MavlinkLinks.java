package org.u2sa.cli.run;

import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.u2sa.core.launch.MavlinkEntry;
import org.u2sa.core.launch.RunningSystem;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.gcs.mavlink.BridgeOptions;
import org.u2sa.gcs.mavlink.MavlinkBridge;
import org.u2sa.gcs.mavlink.SigningKeys;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.mqtt.BrokerAccess;
import org.u2sa.interfaces.mqtt.MqttTransport;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.MessageTypes;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** The option {@code --mavlink}, and the bridges of a system that starts. */
public final class MavlinkLinks {
  private static final double CONNECT_WITHIN_S = 30.0; // a busy machine may start slowly
  private static final double ANSWER_WITHIN_S = 3.0;

  private final List<BridgeOptions> asked = new ArrayList<>();

  @Spec(Spec.Target.MIXEE)
  private CommandSpec command;

  @Option(
      names = "--mavlink",
      paramLabel = "LINK",
      description =
          "Let MAVLink ground stations operate the vehicle: tcp:PORT, udp:HOST:PORT or serial:PATH, each with options, such as tcp:5760,as=ardupilot (docs/mavlink.md). May be given several times.")
  private void mavlink(List<String> links) {
    asked.clear();
    for (String link : links) {
      try {
        asked.add(BridgeOptions.parse(link));
      } catch (IllegalArgumentException e) {
        throw new ParameterException(command.commandLine(), "--mavlink: " + e.getMessage());
      }
    }
  }

  /** Running bridges. */
  @FunctionalInterface
  public interface Bridges extends AutoCloseable {
    @Override
    void close();
  }

  /**
   * Starts the bridges given as options or, if there are none, those of the system file.
   *
   * @throws BadInputException if a link is invalid or in use, or the system has no broker of its
   *     own or one that only admits users, which a link does not have
   */
  public Bridges start(SystemFile file, RunningSystem running, Consumer<String> console) {
    List<BridgeOptions> links = asked.isEmpty() ? ofFile(file) : asked;
    if (!links.isEmpty() && running.communicationManager().isSecured()) {
      throw new BadInputException(
          "MAVLink link "
              + links.get(0)
              + ": the broker has a SECURITY DIRECTORY; expected ./u2sa mavlink beside it, with --user");
    }
    List<MavlinkBridge> started = new ArrayList<>();
    SigningKeys keys = new SigningKeys();
    Bridges bridges = () -> started.forEach(MavlinkBridge::close);
    try {
      for (BridgeOptions link : links) {
        started.add(start(link, file.systemId(), running, keys, console));
      }
    } catch (RuntimeException e) {
      bridges.close();
      throw e;
    }
    return bridges;
  }

  private static List<BridgeOptions> ofFile(SystemFile file) {
    List<BridgeOptions> links = new ArrayList<>();
    for (MavlinkEntry each : file.mavlink()) {
      try {
        links.add(BridgeOptions.parse(each.link()));
      } catch (IllegalArgumentException e) {
        throw each.element().error(e.getMessage());
      }
    }
    return links;
  }

  private static MavlinkBridge start(
      BridgeOptions options,
      String systemId,
      RunningSystem running,
      SigningKeys keys,
      Consumer<String> console) {
    InetSocketAddress broker =
        running
            .communicationManager()
            .address()
            .orElseThrow(
                () ->
                    new BadInputException(
                        "MAVLink link "
                            + options
                            + ": this process runs no broker; expected ./u2sa mavlink beside it"));
    String host = broker.getAddress().isAnyLocalAddress() ? "localhost" : broker.getHostString();
    MqttTransport transport =
        new MqttTransport(
                host,
                broker.getPort(),
                systemId,
                new MessageCodec(MessageTypes.discovered()),
                BrokerAccess.of("", "", false, ""))
            .ofTool()
            .waiting(CONNECT_WITHIN_S);
    RemoteLink link =
        new RemoteLink(transport, "u2sa-mavlink", new SystemClock(), ANSWER_WITHIN_S, console);
    link.keepTime();
    MavlinkBridge bridge = new MavlinkBridge(link, options, keys, console);
    console.accept("MAVLink ground stations: " + options);
    return bridge;
  }
}
