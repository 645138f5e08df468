package org.u2sa.cli.safety;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.mqtt.MqttTransport;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.U2SAData;

/** A system of one service at another system's broker; it reports the stops that it obeys. */
final class ReportingBuoy implements AutoCloseable, Receiver {
  private static final long REPORT_MICROS = 50_000;

  private final SystemClock clock = new SystemClock();
  private final List<String> stops = new CopyOnWriteArrayList<>();
  private final String systemId;
  private final Connection connection;
  private final Thread reports = new Thread(this::report, "buoy");

  private ReportingBuoy(int port, String systemId) {
    this.systemId = systemId;
    connection =
        new MqttTransport("127.0.0.1", port, systemId, new MessageCodec(StandardTypes.registry()))
            .connect("Buoy", this);
  }

  /** Joins the broker and reports until it is closed. */
  static ReportingBuoy join(int port, String systemId) {
    ReportingBuoy buoy = new ReportingBuoy(port, systemId);
    buoy.connection.subscribe(Channels.EMERGENCY_STOP);
    buoy.reports.start();
    return buoy;
  }

  /** Its ID. */
  String systemId() {
    return systemId;
  }

  private void report() {
    try (Clock.Waiter pause = clock.newWaiter("pause")) {
      while (!Thread.currentThread().isInterrupted()) {
        HealthReport report = new HealthReport().serviceName("Buoy").status(ServiceStatus.RUNNING);
        report.emergencyStops(List.copyOf(stops)).systemId(systemId);
        report.timestamp(clock.micros());
        report.freeze();
        connection.publish(Channels.HEALTH, report);
        pause.await(clock.micros() + REPORT_MICROS);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  @Override
  public void receive(Channel<?> channel, U2SAData message) {
    if (message instanceof EmergencyStop stop && stop.active()) {
      stops.add(stop.identity());
    }
  }

  @Override
  public void trouble(String what) {
    throw new IllegalStateException(what);
  }

  @Override
  public void close() {
    reports.interrupt();
    connection.close();
  }
}
