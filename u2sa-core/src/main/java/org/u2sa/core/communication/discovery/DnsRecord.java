package org.u2sa.core.communication.discovery;

import java.io.ByteArrayOutputStream;
import java.net.InetAddress;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * A DNS resource record (RFC 1035). Names are lists of lower-case labels.
 *
 * @param ttlS time to live [s]; 0 withdraws it
 * @param data its content, without compressed names
 */
record DnsRecord(List<String> name, int type, int ttlS, byte[] data) {
  static final int ADDRESS = 1;
  static final int POINTER = 12;
  static final int TEXT = 16;
  static final int SERVICE = 33;
  static final int SERVICE_HEAD = 6; // bytes of priority, weight and port

  /** A pointer from a service type to one of its instances. */
  static DnsRecord pointer(List<String> type, int ttlS, List<String> instance) {
    return new DnsRecord(type, POINTER, ttlS, encoded(instance));
  }

  /** Host and port of an instance. */
  static DnsRecord service(List<String> instance, int ttlS, int port, List<String> host) {
    byte[] target = encoded(host);
    ByteBuffer data = ByteBuffer.allocate(SERVICE_HEAD + target.length);
    data.putInt(0).putShort((short) port).put(target);
    return new DnsRecord(instance, SERVICE, ttlS, data.array());
  }

  /** Properties of an instance (TXT). */
  static DnsRecord text(List<String> instance, int ttlS, List<String> properties) {
    ByteArrayOutputStream data = new ByteArrayOutputStream();
    for (String property : properties) {
      byte[] bytes = property.getBytes(StandardCharsets.UTF_8);
      data.write(bytes.length);
      data.write(bytes, 0, bytes.length);
    }
    return new DnsRecord(instance, TEXT, ttlS, data.toByteArray());
  }

  /** IPv4 address of a host. */
  static DnsRecord address(List<String> host, int ttlS, InetAddress address) {
    return new DnsRecord(host, ADDRESS, ttlS, address.getAddress());
  }

  /** Port of a service. */
  int port() {
    return ByteBuffer.wrap(data).getShort(SERVICE_HEAD - Short.BYTES) & 0xFFFF;
  }

  /** Properties in a TXT record; the first of equal keys counts (RFC 6763, 6.4). */
  Map<String, String> properties() {
    Map<String, String> properties = new HashMap<>();
    for (int at = 0; at < data.length; at += 1 + (data[at] & 0xFF)) {
      int length = Math.min(data[at] & 0xFF, data.length - at - 1);
      String[] pair = new String(data, at + 1, length, StandardCharsets.UTF_8).split("=", 2);
      properties.putIfAbsent(pair[0], pair.length > 1 ? pair[1] : "");
    }
    return properties;
  }

  static byte[] encoded(List<String> name) {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    for (String label : name) {
      byte[] text = label.getBytes(StandardCharsets.UTF_8);
      bytes.write(text.length);
      bytes.write(text, 0, text.length);
    }
    bytes.write(0);
    return bytes.toByteArray();
  }
}
