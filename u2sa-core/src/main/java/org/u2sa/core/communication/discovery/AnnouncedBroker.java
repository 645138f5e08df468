package org.u2sa.core.communication.discovery;

import java.net.InetAddress;
import java.util.List;
import java.util.Locale;

/**
 * A broker as multicast DNS describes it on one network (RFC 6763). Its names contain its ID, so
 * that no other host can have the same.
 */
final class AnnouncedBroker {
  /** DNS-SD service type registered for MQTT. */
  static final List<String> TYPE = List.of("_mqtt", "_tcp", "local");

  /** Property: comma-separated IDs of the systems on the broker; * for any. */
  static final String SYSTEMS = "u2sa";

  /** Property: whether the broker requires TLS. */
  static final String ENCRYPTED = "tls";

  /** Property: unique ID that identifies a broker seen through several networks. */
  static final String ID = "id";

  private static final List<String> TYPES = List.of("_services", "_dns-sd", "_udp", "local");
  private static final int TTL_S = 120; // names with hosts (RFC 6762, 10)
  private static final int LONGEST_LABEL = 63;
  private static final int ID_LENGTH = 9; // its maximum length in names, with hyphen

  private final String systemId;
  private final InetAddress address;
  private final int port;
  private final boolean encrypted;
  private final String id;

  AnnouncedBroker(String systemId, InetAddress address, int port, boolean encrypted, String id) {
    this.systemId = systemId;
    this.address = address;
    this.port = port;
    this.encrypted = encrypted;
    this.id = id;
  }

  /** Whether a message contains a question about this broker. */
  boolean isAskedForBy(DnsMessage message) {
    List<DnsRecord> own = records(TTL_S);
    return message.questions().stream()
        .anyMatch(question -> own.stream().anyMatch(question::asksFor));
  }

  DnsMessage announcement() {
    return new DnsMessage(List.of(), records(TTL_S));
  }

  DnsMessage goodbye() {
    return new DnsMessage(List.of(), records(0));
  }

  private List<DnsRecord> records(int ttlS) {
    String unique = "-" + id.substring(0, Math.min(id.length(), ID_LENGTH - 1));
    String name = ("u2sa-" + systemId).toLowerCase(Locale.ROOT);
    String label = name.substring(0, Math.min(name.length(), LONGEST_LABEL - ID_LENGTH)) + unique;
    List<String> instance = List.of(label, TYPE.get(0), TYPE.get(1), TYPE.get(2));
    List<String> host = List.of("u2sa" + unique, "local");
    return List.of(
        DnsRecord.pointer(TYPE, ttlS, instance),
        DnsRecord.pointer(TYPES, ttlS, TYPE),
        DnsRecord.service(instance, ttlS, port, host),
        DnsRecord.text(
            instance,
            ttlS,
            List.of(SYSTEMS + "=" + systemId, ENCRYPTED + "=" + encrypted, ID + "=" + id)),
        DnsRecord.address(host, ttlS, address));
  }
}
