package org.u2sa.core.communication;

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
 * Tells the local network by multicast DNS where this system's broker listens. Announcing takes
 * seconds, so it is done on a thread of its own, as is taking it back.
 */
final class BrokerAnnouncement implements AutoCloseable {
  /** The kind of service, as registered for MQTT. */
  static final String TYPE = "_mqtt._tcp.local.";

  /** Key of the IDs of the systems that talk over the broker, with commas between; * for any. */
  static final String SYSTEMS = "u2sa";

  /** Key of whether the broker wants TLS. */
  static final String ENCRYPTED = "tls";

  /** Key of what tells brokers apart that are seen through several networks. */
  static final String ID = "id";

  private static final long GOODBYE_WITHIN_MS = 700;

  private final String bindAddress;
  private final String systemId;
  private final int port;
  private final boolean encrypted;
  private final Consumer<String> log;
  private final List<JmDNS> open = new ArrayList<>(); // this and the following under this
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
   * Begins to announce; what does not work is told to the log only, since the broker serves
   * without.
   *
   * @param bindAddress where the broker listens
   */
  static BrokerAnnouncement start(
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
    } catch (IOException | RuntimeException e) { // the latter as when closed meanwhile
      log.accept(
          "the broker is not announced by mDNS through "
              + address.getHostAddress()
              + ": "
              + e.getMessage());
    }
  }

  /** Says goodbye, and returns after a short while in any case. */
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
        goodbye.join(GOODBYE_WITHIN_MS); // the first word goes out at once, it is repeated for 2 s
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
