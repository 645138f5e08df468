package org.u2sa.gcs.mavlink;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Supplier;
import org.u2sa.gcs.mavlink.vehicle.Identity;
import org.u2sa.gcs.mavlink.vehicle.VehicleKind;

/**
 * Options of a bridge: its link to the stations, and how it presents the vehicle.
 *
 * @param place link to the stations
 * @param systemId MAVLink system ID of the vehicle, 1…250
 * @param kind kind of the vehicle; empty: determined by its control service
 * @param key file with the message-signing passphrase; empty: unsigned
 * @param logs folder whose recordings stations may download; empty: none
 */
public record BridgeOptions(
    StationPlace place,
    Identity identity,
    Optional<VehicleKind> kind,
    int systemId,
    Optional<Path> key,
    Optional<Path> logs) {
  private static final int MAX_SYSTEM_ID = 250;
  private static final int HIGHEST_PORT = 65_535;
  private static final int USUAL_BAUD = 57_600; // default of telemetry radios
  private static final int FASTEST_BAUD = 4_000_000;
  private static final String FORM =
      "expected tcp:PORT, tcp:HOST:PORT, udp:HOST:PORT or serial:PATH, then baud=1…4000000 (serial), as=px4|ardupilot|generic, type=rover|boat|plane|copter|submarine|generic, id=1…250, key=FILE or logs=FOLDER, separated by commas";

  /**
   * Parses {@code tcp:5760} or {@code udp:127.0.0.1:14550,as=ardupilot,id=2}.
   *
   * @throws IllegalArgumentException naming text and expectation
   */
  public static BridgeOptions parse(String text) {
    String[] parts = text.split(",", -1);
    Identity identity = Identity.PX4;
    Optional<VehicleKind> kind = Optional.empty();
    int systemId = 1;
    Optional<Path> key = Optional.empty();
    Optional<Path> logs = Optional.empty();
    OptionalInt baud = OptionalInt.empty();
    for (int i = 1; i < parts.length; i++) {
      String[] pair = parts[i].split("=", 2);
      String value = pair.length == 2 ? pair[1] : "";
      switch (pair[0]) {
        case "as" -> identity = named(text, () -> Identity.parse(value));
        case "type" -> kind = Optional.of(named(text, () -> VehicleKind.parse(value)));
        case "id" -> systemId = number(text, value, MAX_SYSTEM_ID);
        case "key" -> key = Optional.of(Path.of(value));
        case "baud" -> baud = OptionalInt.of(number(text, value, FASTEST_BAUD));
        case "logs" -> logs = Optional.of(folder(text, value));
        default -> throw wrong(text, FORM);
      }
    }
    StationPlace place = place(text, parts[0], baud, key.isPresent());
    return new BridgeOptions(place, identity, kind, systemId, key, logs);
  }

  private static StationPlace place(String text, String place, OptionalInt baud, boolean isSigned) {
    String target = place.substring(place.indexOf(':') + 1);
    boolean isSerial = place.startsWith("serial:");
    boolean tcp = place.startsWith("tcp:");
    if (!isSerial && !tcp && !place.startsWith("udp:")
        || isSerial && target.isEmpty()
        || !isSerial && baud.isPresent()) {
      throw wrong(text, FORM);
    }
    if (isSerial) {
      return new StationPlace.Serial(target, baud.orElse(USUAL_BAUD));
    }
    InetSocketAddress address = address(text, target, tcp);
    if (!address.getAddress().isLoopbackAddress() && !isSigned) {
      throw wrong(
          text, "addresses other than this host's need message signing; expected key=FILE as well");
    }
    return tcp ? new StationPlace.Tcp(address) : new StationPlace.Udp(address);
  }

  private static Path folder(String text, String value) {
    if (value.isEmpty()) {
      throw wrong(text, "logs: expected the recordings' folder");
    }
    return Path.of(value);
  }

  private static InetSocketAddress address(String text, String place, boolean tcp) {
    int colon = place.lastIndexOf(':');
    if (colon < 0 && !tcp) {
      throw wrong(text, FORM);
    }
    String host = colon < 0 ? "127.0.0.1" : place.substring(0, colon);
    int port = number(text, place.substring(colon + 1), HIGHEST_PORT);
    try {
      return new InetSocketAddress(InetAddress.getByName(host), port);
    } catch (UnknownHostException e) {
      throw wrong(text, "no host \"" + host + "\" found");
    }
  }

  private static int number(String text, String value, int highest) {
    if (!value.matches("[1-9][0-9]{0,6}") || Integer.parseInt(value) > highest) {
      throw wrong(text, "\"" + value + "\": expected 1…" + highest);
    }
    return Integer.parseInt(value);
  }

  private static <T> T named(String text, Supplier<T> parsed) {
    try {
      return parsed.get();
    } catch (IllegalArgumentException e) {
      throw wrong(text, e.getMessage());
    }
  }

  private static IllegalArgumentException wrong(String text, String why) {
    return new IllegalArgumentException("MAVLink link \"" + text + "\": " + why);
  }

  @Override
  public String toString() {
    return place.toString();
  }
}
