package org.u2sa.drivers.link;

import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Optional;
import java.util.Set;
import java.util.function.UnaryOperator;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.mqtt.BrokerAccess;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.service.ServiceContext;

/** Opens links by address, as written in configuration files. */
public final class ByteLinks {

  private static final double TCP_SILENCE_S = 5.0;
  private static final double UDP_SILENCE_S = 2.0;
  private static final double LONGEST_SILENCE_S = 3_600.0;
  private static final double FASTEST_REPLAY = 1_000.0;

  private ByteLinks() {}

  /**
   * Opens the link of a service's variable CONNECTION; files are relative to the configuration.
   *
   * @throws BadInputException if the address is invalid
   */
  public static ByteLink of(ServiceContext context) {
    String address = (String) context.configuration().getVariable("CONNECTION");
    context.beforeDevice();
    return open(address, context.clock(), path -> context.configuration().resolve(path.toString()));
  }

  /**
   * As {@link #open(String, Clock, UnaryOperator)}; files are relative to the working directory.
   */
  public static ByteLink open(String address, Clock clock) {
    return open(address, clock, path -> path);
  }

  /**
   * Opens a link. Returns immediately; the device may be absent.
   *
   * <ul>
   *   <li>{@code serial:PATH?baud=9600&parity=none&stop=1}: 8 data bits; parity none, even or odd;
   *       {@code &dtr=off} lowers Data Terminal Ready, which stops some devices
   *   <li>{@code tcp:HOST:PORT?silence=5}: a device server, as client; after this many seconds
   *       without a byte, the connection counts as lost and is re-established; 0: never
   *   <li>{@code udp:PORT?silence=2&senders=first}: datagrams to that port, from its first sender
   *       until that is silent (0: for 2 s); with {@code all} from anyone; replies go to the first
   *       sender
   *   <li>{@code udp:HOST:PORT?silence=2}: datagrams to and from that device
   *   <li>{@code replay:FILE?speed=1}: a recording, played at this multiple of its speed; lost at
   *       its end
   * </ul>
   *
   * @param clock the run's clock, for recording timestamps and replay speed
   * @param files resolves relative file names; from {@code XmlConfiguration.resolve}
   * @throws BadInputException if the address is invalid; the message quotes it and states what was
   *     expected
   */
  public static ByteLink open(String address, Clock clock, UnaryOperator<Path> files) {
    LinkAddress parsed = new LinkAddress(address);
    String record = parsed.option("record");
    ByteLink link = open(parsed, clock, files);
    if (record.isEmpty()) {
      return link;
    }
    try {
      return new RecordingLink(link, files.apply(Paths.get(record)), clock);
    } catch (BadInputException e) {
      link.close();
      throw e;
    }
  }

  /**
   * Opener of {@code serial:PATH} or {@code tcp:HOST:PORT}, for callers that manage the connection
   * themselves. Opening a serial port raises DTR.
   *
   * @throws BadInputException if the address is neither
   */
  public static Port.Opener opener(String address) {
    LinkAddress parsed = new LinkAddress(address);
    if (parsed.kind().equals("serial")) {
      return new SerialOpener(parsed, true);
    }
    if (!parsed.kind().equals("tcp") || parsed.host().isEmpty()) {
      throw parsed.refused("expected serial:PATH or tcp:HOST:PORT");
    }
    return new TcpOpener(parsed.host(), parsed.port(), Optional.empty());
  }

  /**
   * Opener of {@code tls:HOST:PORT}, a device that requires a user.
   *
   * @throws BadInputException if the address is invalid
   */
  public static Port.Opener opener(String address, BrokerAccess access) {
    LinkAddress parsed = new LinkAddress(address);
    if (!parsed.kind().equals("tls") || parsed.host().isEmpty()) {
      throw parsed.refused("expected tls:HOST:PORT");
    }
    return new TcpOpener(parsed.host(), parsed.port(), Optional.of(access));
  }

  private static ByteLink open(LinkAddress address, Clock clock, UnaryOperator<Path> files) {
    switch (address.kind()) {
      case "serial":
        address.onlyOptions(Set.of("baud", "parity", "stop", "dtr", "record"));
        return new ReconnectingLink(address.toString(), new SerialOpener(address, false), 0.0);
      case "tcp":
        address.onlyOptions(Set.of("silence", "record"));
        if (address.host().isEmpty()) {
          throw address.refused("no host; expected tcp:HOST:PORT");
        }
        return new ReconnectingLink(
            address.toString(),
            new TcpOpener(address.host(), address.port(), Optional.empty()),
            address.option("silence", TCP_SILENCE_S, 0.0, LONGEST_SILENCE_S));
      case "udp":
        return udp(address);
      case "replay":
        address.onlyOptions(Set.of("speed", "record"));
        return new ReplayLink(
            files.apply(Paths.get(address.target())),
            clock,
            address.option("speed", 1.0, 1.0 / FASTEST_REPLAY, FASTEST_REPLAY));
      default:
        throw address.refused("unknown kind \"" + address.kind() + "\"; " + LinkAddress.EXPECTED);
    }
  }

  private static ByteLink udp(LinkAddress address) {
    boolean isListening = address.host().isEmpty();
    address.onlyOptions(
        isListening ? Set.of("silence", "senders", "record") : Set.of("silence", "record"));
    double silenceS = address.option("silence", UDP_SILENCE_S, 0.0, LONGEST_SILENCE_S);
    String senders = address.option("senders");
    if (!Set.of("", "first", "all").contains(senders)) {
      throw address.refused("option \"senders\": \"" + senders + "\"; expected first or all");
    }
    return new ReconnectingLink(
        address.toString(),
        new UdpOpener(
            address.host(),
            address.port(),
            senders.equals("all"),
            silenceS > 0.0 ? silenceS : UDP_SILENCE_S),
        silenceS);
  }
}
