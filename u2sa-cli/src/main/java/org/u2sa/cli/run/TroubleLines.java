package org.u2sa.cli.run;

import java.util.HashMap;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.u2sa.interfaces.OneLine;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.communication.Transport;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.schema.U2SAData;

/**
 * Prints troubles reported by services, such as a missing device, which would otherwise appear only
 * in their log files. Each text is printed once, and each service is limited to one line every few
 * seconds.
 */
public final class TroubleLines implements Receiver, AutoCloseable {
  private static final long APART_MICROS = 5_000_000;
  private static final int MAX_TEXT = 300;
  private static final int MAX_SERVICES = 1_000;

  /** Sent as every client's last will: the process's supervisor reports what happened. */
  private static final String LOST = "connection lost";

  private record Printed(String text, long micros) {}

  private final Predicate<String> services;
  private final Clock clock;
  private final Consumer<String> console;
  private final Map<String, Printed> printed = new HashMap<>(); // by service name; guarded by this
  private final Map<String, String> latest = new TreeMap<>(); // likewise; of all services
  private final Connection connection;

  /**
   * @param transport to the system's messages
   * @param services services whose faults are printed
   * @param clock of the run
   * @param console receives the lines
   */
  public TroubleLines(
      Transport transport, Predicate<String> services, Clock clock, Consumer<String> console) {
    this.services = services;
    this.clock = clock;
    this.console = console;
    connection = transport.connect("u2sa-run-troubles", this);
    connection.subscribe(Channels.HEALTH);
  }

  @Override
  public void receive(Channel<?> channel, U2SAData message) {
    if (message instanceof HealthReport report
        && report.lastError().filter(text -> !text.equals(LOST)).isPresent()) {
      take(report.serviceName(), report.lastError().get());
    }
  }

  private synchronized void take(String service, String text) {
    if (latest.containsKey(service) || latest.size() < MAX_SERVICES) {
      latest.put(service, text);
    }
    if (services.test(service)) {
      print(service, text, APART_MICROS);
    }
  }

  /** Prints the latest trouble of each service that was not printed when it was reported. */
  public synchronized void printRest() {
    latest.forEach((service, text) -> print(service, text, 0L));
  }

  private void print(String service, String text, long apartMicros) {
    long now = clock.micros();
    Printed last = printed.get(service);
    boolean isNews = last == null || !last.text().equals(text);
    boolean isSoon = last != null && now - last.micros() < apartMicros;
    if (isNews && !isSoon && (last != null || printed.size() < MAX_SERVICES)) {
      printed.put(service, new Printed(text, now));
      String cut = text.length() > MAX_TEXT ? text.substring(0, MAX_TEXT) + "…" : text;
      console.accept(OneLine.of(service + ": " + cut));
    }
  }

  @Override
  public void trouble(String what) {
    console.accept(what);
  }

  @Override
  public void close() {
    connection.close();
  }
}
