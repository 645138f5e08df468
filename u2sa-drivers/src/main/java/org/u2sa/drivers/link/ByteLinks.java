package org.u2sa.drivers.link;

import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Set;
import java.util.function.UnaryOperator;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.service.ServiceContext;

/** Opens links from the addresses that users write in configuration files. */
public final class ByteLinks {

  private static final double TCP_SILENCE_S = 5.0;
  private static final double UDP_SILENCE_S = 2.0;
  private static final double LONGEST_SILENCE_S = 3_600.0;
  private static final double FASTEST_REPLAY = 1_000.0;

  private ByteLinks() {}

  /**
   * The link that a service's variable CONNECTION names; files are relative to the configuration.
   *
   * @throws BadInputException if the address is none
   */
  public static ByteLink of(ServiceContext context) {
    return open(
        (String) context.configuration().getVariable("CONNECTION"),
        context.clock(),
        path -> context.configuration().resolve(path.toString()));
  }

  /**
   * As {@link #open(String, Clock, UnaryOperator)}; files are relative to the working directory.
   */
  public static ByteLink open(String address, Clock clock) {
    return open(address, clock, path -> path);
  }

  /**
   * Opens a link. Returns at once: the device need not be there yet.
   *
   * <ul>
   *   <li>{@code serial:PATH?baud=9600&parity=none&stop=1}: 8 data bits; parity none, even or odd;
   *       {@code &dtr=off} drops the line Data Terminal Ready, which stops some devices
   *   <li>{@code tcp:HOST:PORT?silence=5}: a device server, as client; after so many seconds
   *       without a byte the connection counts as lost and is made anew; 0: never
   *   <li>{@code udp:PORT?silence=2}: datagrams to that port, from anyone; answers go to who spoke
   *       last
   *   <li>{@code udp:HOST:PORT?silence=2}: datagrams to and from that device
   *   <li>{@code replay:FILE?speed=1}: a recording, so much faster than it was made; ends lost
   * </ul>
   *
   * @param clock the run's clock: times in recordings, and the pace of replays
   * @param files where a relative file is; from {@code XmlConfiguration.resolve}
   * @throws BadInputException if the address is none; the message quotes it and says what was
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
   * A way to open the device at {@code serial:PATH} or {@code tcp:HOST:PORT}, for those who look
   * for it themselves. A serial device sees DTR rise.
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
    return new TcpOpener(parsed.host(), parsed.port());
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
            new TcpOpener(address.host(), address.port()),
            address.option("silence", TCP_SILENCE_S, 0.0, LONGEST_SILENCE_S));
      case "udp":
        address.onlyOptions(Set.of("silence", "record"));
        return new ReconnectingLink(
            address.toString(),
            new UdpOpener(address.host(), address.port()),
            address.option("silence", UDP_SILENCE_S, 0.0, LONGEST_SILENCE_S));
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
}
