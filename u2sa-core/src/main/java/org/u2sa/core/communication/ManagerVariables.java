package org.u2sa.core.communication;

import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.cbor.WireForm;

/** Variables of the {@link CommunicationManager}, except limits and security. */
public record ManagerVariables(
    @Variable(
            oneOf = {"embedded", "external", "none"},
            ifAbsentText = "embedded")
        @Description(
            "embedded: a broker in this process; external: another MQTT broker; none: this process only.")
        String broker,
    @Variable(ifAbsentText = "127.0.0.1")
        @Description(
            "Address on which the embedded broker listens; 0.0.0.0 opens it to the network, which requires SECURITY DIRECTORY.")
        String bindAddress,
    @Variable(ifAbsentText = "localhost")
        @Description(
            "Host of the external broker; auto: the one announced by mDNS for this system.")
        String communicationManagerIp,
    @Variable(min = 1, max = 65_535, ifAbsent = 1883)
        @Description("TCP port of the embedded or external broker.")
        int communicationManagerPort,
    @Variable(max = 65_535, ifAbsent = 0)
        @Description(
            "TCP port on which the embedded broker serves the operator's page, at BIND ADDRESS; 0: none.")
        int webPort,
    @Variable(ifAbsentText = "")
        @Description(
            "File of raster map tiles (PMTiles) that the operator's page shows; empty: none.")
        String webTiles,
    @Variable(max = 65_535, ifAbsent = 0)
        @Description(
            "TCP port on which clients of the rosbridge protocol connect, at BIND ADDRESS; 0: none.")
        int rosbridgePort,
    @Variable(unit = "s", min = 0, max = 3600, ifAbsent = 0)
        @Description(
            "Time to wait for an external broker at startup, so that hosts may start in any order.")
        double communicationManagerWait,
    @Variable(
            oneOf = {"auto", "yes", "no"},
            ifAbsentText = "auto")
        @Description(
            "Whether the embedded broker announces itself by mDNS; auto: if it listens on a network.")
        String announce,
    @Variable(
            oneOf = {READABLE, COMPACT},
            ifAbsentText = READABLE)
        @Description(
            "How this process writes messages. readable: fields by name, for any CBOR tool; compact: fields by number and lists as typed arrays, about half the size for small messages, for readers of format 3 and later.")
        String wireForm) {
  /** Name of the variable {@link #broker}. */
  public static final String BROKER = "BROKER";

  /** Name of the variable {@link #communicationManagerPort}. */
  public static final String PORT = "COMMUNICATION MANAGER PORT";

  /** Name of the variable {@link #webPort}. */
  public static final String WEB_PORT = "WEB PORT";

  /** Name of the variable {@link #rosbridgePort}. */
  public static final String ROSBRIDGE_PORT = "ROSBRIDGE PORT";

  static final String READABLE = "readable";

  static final String COMPACT = "compact";

  WireForm form() {
    return wireForm.equals(COMPACT) ? WireForm.COMPACT : WireForm.READABLE;
  }

  boolean announces() {
    return announce.equals("yes")
        || announce.equals("auto") && !BrokerSecurity.isLoopback(bindAddress);
  }
}
