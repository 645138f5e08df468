package org.u2sa.drivers.link;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.u2sa.interfaces.BadInputException;

/**
 * Address of a device as written by users: {@code serial:/dev/ttyUSB0?baud=9600}, {@code
 * tcp:192.168.1.7:4001}, {@code udp:10110}, {@code udp:192.168.1.7:10110}, {@code
 * replay:gps.rec?speed=2}; each with {@code &record=FILE}.
 */
final class LinkAddress {
  /** Expected forms, for error messages. */
  static final String EXPECTED =
      "expected serial:PATH?baud=N, tcp:HOST:PORT, udp:PORT, udp:HOST:PORT or replay:FILE";

  private static final int HIGHEST_PORT = 65_535;

  private final String text;
  private final String kind;
  private final String target;
  private final Map<String, String> options = new LinkedHashMap<>();

  /**
   * @throws BadInputException if it is not KIND:TARGET with options that have a name and a value
   */
  LinkAddress(String text) {
    this.text = text;
    int colon = text.indexOf(':');
    int question = text.indexOf('?');
    int end = question < 0 ? text.length() : question;
    if (colon < 1 || colon >= end - 1) {
      throw refused(EXPECTED);
    }
    kind = text.substring(0, colon);
    target = text.substring(colon + 1, end);
    if (question >= 0) {
      for (String option : text.substring(question + 1).split("&", -1)) {
        int equals = option.indexOf('=');
        if (equals < 1 || equals == option.length() - 1) {
          throw refused("option \"" + option + "\" is not NAME=VALUE");
        }
        options.put(option.substring(0, equals), option.substring(equals + 1));
      }
    }
  }

  String kind() {
    return kind;
  }

  /** Text between kind and options. */
  String target() {
    return target;
  }

  /** Host of HOST:PORT or [IPV6]:PORT; empty if only a port is given. */
  String host() {
    int colon = target.lastIndexOf(':');
    String host = colon < 0 ? "" : target.substring(0, colon);
    return host.startsWith("[") && host.endsWith("]") ? host.substring(1, host.length() - 1) : host;
  }

  /** Port of HOST:PORT or PORT. */
  int port() {
    String port = target.substring(target.lastIndexOf(':') + 1);
    return whole("port", port, 1, HIGHEST_PORT);
  }

  /** An integer option. */
  int option(String name, int ifAbsent, int lowest, int highest) {
    String value = options.get(name);
    return value == null ? ifAbsent : whole("option \"" + name + "\"", value, lowest, highest);
  }

  /** A numeric option. */
  double option(String name, double ifAbsent, double lowest, double highest) {
    String value = options.get(name);
    if (value == null) {
      return ifAbsent;
    }
    try {
      double number = Double.parseDouble(value);
      if (number >= lowest && number <= highest) {
        return number;
      }
    } catch (NumberFormatException e) {
      throw notANumber("option \"" + name + "\"", value, lowest + "…" + highest, e);
    }
    throw refused("option \"" + name + "\": " + value + " is outside " + lowest + "…" + highest);
  }

  /** An on/off option. */
  boolean flag(String name, boolean ifAbsent) {
    String value = options.getOrDefault(name, ifAbsent ? "on" : "off");
    if (!value.equals("on") && !value.equals("off")) {
      throw refused("option \"" + name + "\": \"" + value + "\" is neither on nor off");
    }
    return value.equals("on");
  }

  /** A text option; empty if absent. */
  String option(String name) {
    return options.getOrDefault(name, "");
  }

  /**
   * @throws BadInputException if there are other options
   */
  void onlyOptions(Set<String> known) {
    for (String name : options.keySet()) {
      if (!known.contains(name)) {
        throw refused(
            "unknown option \"" + name + "\"; known for " + kind + ": " + new TreeSet<>(known));
      }
    }
  }

  BadInputException refused(String why) {
    return new BadInputException("link address \"" + text + "\": " + why);
  }

  private int whole(String what, String value, int lowest, int highest) {
    try {
      int number = Integer.parseInt(value);
      if (number >= lowest && number <= highest) {
        return number;
      }
    } catch (NumberFormatException e) {
      throw notANumber(what, value, lowest + "…" + highest, e);
    }
    throw refused(what + ": " + value + " is outside " + lowest + "…" + highest);
  }

  private BadInputException notANumber(String what, String value, String range, Throwable cause) {
    return new BadInputException(
        "link address \"" + text + "\": " + what + ": \"" + value + "\"; expected " + range, cause);
  }

  @Override
  public String toString() {
    return text;
  }
}
