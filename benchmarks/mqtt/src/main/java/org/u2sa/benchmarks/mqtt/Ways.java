package org.u2sa.benchmarks.mqtt;

import java.util.List;

/**
 * Makes the halves of ways by name: {@code CLIENT-BROKER}, where the client is u2sa (connection to
 * connection), service (service to service's callback), paho or hivemq, and the broker ours (the
 * embedded one, with our rules), moquette (bare) or mosquitto; or jeromq (ZeroMQ without a
 * broker), or tcp, or handoff.
 */
final class Ways {
  static final List<String> ALL =
      List.of(
          "u2sa-ours",
          "service-ours",
          "paho-ours",
          "hivemq-ours",
          "u2sa-mosquitto",
          "service-mosquitto",
          "paho-mosquitto",
          "hivemq-mosquitto",
          "paho-moquette",
          "hivemq-moquette",
          "jeromq",
          "tcp",
          "handoff");

  /**
   * What is sent.
   *
   * @param bytes of contents; U2SA's messages have their names and origin besides
   * @param quality MQTT's quality of service, 0 or 1
   */
  record Load(int bytes, int quality) {}

  private Ways() {}

  /** The broker of a way; empty if it has none. */
  static String broker(String way) {
    int dash = way.indexOf('-');
    return dash < 0 ? "" : way.substring(dash + 1);
  }

  /**
   * The half that listens. It is there first.
   *
   * @param port the broker's, or for tcp where to listen
   */
  static Way listening(String way, int port, Load load, Way.Sink sink) throws Exception {
    return make(way, port, load, sink);
  }

  /** The half that sends. */
  static Way sending(String way, int port, Load load) throws Exception {
    return make(way, port, load, null);
  }

  private static Way make(String way, int port, Load load, Way.Sink sink) throws Exception {
    return switch (way.split("-")[0]) {
      case "u2sa" -> new U2saWay(port, load, sink);
      case "service" -> new ServiceWay(port, load, sink);
      case "paho" -> new PahoWay(port, load, sink);
      case "hivemq" -> new HiveWay(port, load, sink);
      case "jeromq" -> new JeroWay(port, load, sink);
      case "tcp" -> new TcpWay(port, load, sink);
      default -> throw new IllegalArgumentException("way \"" + way + "\": expected one of " + ALL);
    };
  }
}
