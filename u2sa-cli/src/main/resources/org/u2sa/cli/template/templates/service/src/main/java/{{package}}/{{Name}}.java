package {{package}};

import org.u2sa.messages.StateInformation;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;
import org.u2sa.service.U2SAService;

/** Measures the vehicle's altitude above mean sea level. In: state. Out: sensed-state. */
public final class {{Name}} extends U2SAService {
  private static final long PERIOD_MS = 100;
  private static final double SUSPICIOUS_M = 20.0;

  private volatile double altitudeM; // written by run(), read by callback(): two threads

  public {{Name}}(ServiceContext context) {
    super(context, ServiceRole.PROPRIOCEPTIVE_SENSOR, "{{Name}}");
    getVariable("NOISE"); // without it in the file, the service does not start
    registerPublisher("sensed-state");
    registerSubscriber("state");
  }

  @Override
  public void run() {
    while (running) {
      altitudeM = 100.0 + 5.0 * Math.sin(nowS() / 10.0); // read your device here
      publish(
          "sensed-state",
          new StateInformation()
              .sensorName(getServiceName())
              .z(altitudeM)
              .zSigma((Double) getVariable("NOISE")));
      try {
        sleep(PERIOD_MS);
      } catch (InterruptedException e) {
        running = false;
      }
    }
  }

  @Override
  public void callback(U2SAData data) {
    if (data instanceof StateInformation state) {
      state.z().ifPresent(this::compare);
    } else {
      log("unexpected message: " + data);
    }
  }

  private void compare(double estimatedM) {
    if (Math.abs(estimatedM - altitudeM) > SUSPICIOUS_M) {
      log("measured " + altitudeM + " m, but the vehicle is said to be at " + estimatedM + " m");
    }
  }

  @Override
  public void kill() {
    running = false; // and close your device here
  }
}
