package org.u2sa.core.communication.discovery;

import java.io.IOException;
import java.net.InetAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import java.util.function.Consumer;
import javax.jmdns.JmDNS;
import javax.jmdns.ServiceInfo;

/**
 * Announces the address of this system's broker by multicast DNS. Announcing and withdrawing take
 * seconds and run on a separate thread.
 */
public final class BrokerAnnouncement implements AutoCloseable {
  /** DNS-SD service type registered for MQTT. */
  static final String TYPE = "_mqtt._tcp.local.";

  /** TXT key: comma-separated IDs of the systems on the broker; * for any. */
  static final String SYSTEMS = "u2sa";

  /** TXT key: whether the broker requires TLS. */
  static final String ENCRYPTED = "tls";

  /** TXT key: unique ID that identifies a broker seen through several networks. */
  static final String ID = "id";

  private static final long GOODBYE_WITHIN_MS = 700;

  private final String bindAddress;
  private final String systemId;
  private final int port;
  private final boolean encrypted;
  private final Consumer<String> log;
  private final List<JmDNS> open = new ArrayList<>(); // guarded by this, like those below
  private boolean closed;

  private BrokerAnnouncement(
      String bindAddress, String systemId, int port, boolean encrypted, Consumer<String> log) {
    this.bindAddress = bindAddress;
    this.systemId = systemId;
    this.port = port;
    this.encrypted = encrypted;
    this.log = log;
  }

  /**
   * Starts announcing. Failures are only logged, since the broker works without announcements.
   *
   * @param bindAddress address the broker listens on
   */
  public static BrokerAnnouncement start(
      String bindAddress, String systemId, int port, boolean encrypted, Consumer<String> log) {
    BrokerAnnouncement announcement =
        new BrokerAnnouncement(bindAddress, systemId, port, encrypted, log);
    daemon(announcement::announce);
    return announcement;
  }

  private static Thread daemon(Runnable task) {
    Thread thread = new Thread(task, "u2sa-announcement");
    thread.setDaemon(true);
    thread.start();
    return thread;
  }

  private void announce() {
    String id = UUID.randomUUID().toString();
    try {
      for (InetAddress address : MulticastAddresses.of(bindAddress)) {
        announce(address, id);
      }
    } catch (IOException e) {
      log.accept("the broker is not announced by mDNS: " + e.getMessage());
    }
  }

  private void announce(InetAddress address, String id) {
    try {
      JmDNS dns = JmDNS.create(address, "u2sa-" + systemId);
      boolean late;
      synchronized (this) {
        late = closed;
        open.add(dns);
      }
      if (late) {
        dns.close();
        return;
      }
      Map<String, String> properties =
          Map.of(SYSTEMS, systemId, ENCRYPTED, String.valueOf(encrypted), ID, id);
      dns.registerService(ServiceInfo.create(TYPE, "u2sa-" + systemId, port, 0, 0, properties));
    } catch (IOException | RuntimeException e) { // the latter e.g. when closed concurrently
      log.accept(
          String.format(
              "the broker is not announced by mDNS through %s: %s",
              address.getHostAddress(), e.getMessage()));
    }
  }

  /** Withdraws the announcement (mDNS goodbye); returns after a short time in any case. */
  @Override
  public void close() {
    List<JmDNS> toClose;
    synchronized (this) {
      closed = true;
      toClose = new ArrayList<>(open);
      open.clear();
    }
    List<Thread> goodbyes = new ArrayList<>();
    toClose.forEach(dns -> goodbyes.add(daemon(() -> close(dns))));
    try {
      for (Thread goodbye : goodbyes) {
        goodbye.join(GOODBYE_WITHIN_MS); // the first is sent immediately, repeats follow for 2 s
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private void close(JmDNS dns) {
    try {
      dns.close();
    } catch (IOException e) {
      log.accept("mDNS could not be ended: " + e.getMessage());
    }
  }
}
