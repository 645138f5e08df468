package org.u2sa.chaos;

import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.function.Predicate;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.testkit.Mosquitto;

/** All that can be broken, and the breaking of it. */
final class Scene {
  private static final int GARBAGE_BYTES = 4_096;
  private static final List<String> GARBAGE_TOPICS =
      List.of(
          "u2sa/cessna/actuation/ActuatorCommand/PercentageCommand",
          "u2sa/cessna/sensed-state/StateInformation/AircraftState",
          "u2sa/cessna/state/StateInformation/AircraftState",
          "u2sa/cessna/goals/GoalList",
          "u2sa/cessna/navigation/NavigationPoint",
          "u2sa/cessna/configuration/ConfigurationTransaction",
          "u2sa/cessna/health/HealthReport",
          "u2sa/cessna/stop/StopCommand",
          "u2sa/cessna/emergency-stop/EmergencyStop",
          "u2sa/cessna/service-orders/ServiceOrder",
          "u2sa//stop/StopCommand");

  private final Vehicle vehicle;
  private final Mosquitto broker;
  private final TcpProxy network;
  private final Map<String, String> serviceNames; // by the simple name of the class
  private final Path folder;
  private final Clock.Waiter waiter;
  private final Clock clock;

  /**
   * @param serviceNames the services that may be broken, by the simple name of their class
   * @param folder for files that foreign programs are to read
   */
  Scene(
      Vehicle vehicle,
      Mosquitto broker,
      TcpProxy network,
      Map<String, String> serviceNames,
      Path folder,
      Clock clock) {
    this.vehicle = vehicle;
    this.broker = broker;
    this.network = network;
    this.serviceNames = serviceNames;
    this.folder = folder;
    this.clock = clock;
    waiter = clock.newWaiter("chaos");
  }

  /** The class name of the service that a fault is for. */
  String victim(Fault fault) {
    List<String> all = new ArrayList<>(serviceNames.keySet());
    return all.get(fault.draw() % all.size());
  }

  /** Breaks something and, if it lasts, mends it again. What ends a service is not mended here. */
  void happen(Fault fault) throws Exception {
    String service = serviceNames.get(victim(fault));
    Predicate<String> one = clientId -> clientId.contains("/" + service + "/");
    Random random = new Random(fault.seed());
    switch (fault.kind()) {
      case KILL -> Signal.KILL.send(process(fault));
      case FREEZE -> Signal.STOP.send(process(fault));
      case HANG -> hang(fault, service);
      case BROKER_RESTART -> {
        broker.kill();
        pause(fault.durationS());
        broker.start();
      }
      case CUT_ONE -> network.cut(one);
      case CUT_ALL -> {
        network.refuse(true);
        network.cut(all -> true);
        pause(fault.durationS());
        network.refuse(false);
      }
      case STALL_ONE -> stall(one, fault.durationS());
      case STALL_ALL -> stall(all -> true, fault.durationS());
      case GARBAGE_IN_STREAM -> network.inject(one, garbage(random));
      case GARBAGE_AT_BROKER -> send(broker.port(), garbage(random));
      case GARBAGE_MESSAGES -> garbageMessages(random);
      case FLOOD -> Flood.of(network.port(), clock, fault.durationS());
      case AIRCRAFT_CUT -> cutAircraft();
      case AIRCRAFT_GARBAGE -> {
        send(vehicle.linesPort(), garbage(random));
        send(vehicle.controlsPort(), garbage(random));
      }
      default -> throw new IllegalStateException("no such fault: " + fault);
    }
  }

  private ProcessHandle process(Fault fault) {
    ProcessHandle process = vehicle.processes().get(victim(fault));
    if (process == null) {
      throw new IllegalStateException("no process runs " + victim(fault));
    }
    return process;
  }

  /** Holds a thread until its process was ended, as a hung callback would stay hung. */
  @SuppressWarnings("try") // it is there to be closed
  private void hang(Fault fault, String threadName) throws Exception {
    ProcessHandle process = process(fault);
    try (HeldThread held = HeldThread.hold(process, threadName)) {
      long deadline = clock.micros() + Clock.micros(30.0);
      while (process.isAlive() && clock.micros() < deadline) {
        pause(0.1);
      }
    }
  }

  private void stall(Predicate<String> clientIds, double seconds) throws InterruptedException {
    network.stall(clientIds, true);
    pause(seconds);
    network.stall(clientIds, false);
  }

  private static byte[] garbage(Random random) {
    byte[] bytes = new byte[1 + random.nextInt(GARBAGE_BYTES)];
    random.nextBytes(bytes);
    return bytes;
  }

  private static void send(int port, byte[] bytes) {
    try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port);
        OutputStream out = socket.getOutputStream()) {
      out.write(bytes);
    } catch (IOException e) {
      return; // it is not there, or it hung up: either is its right
    }
  }

  private void garbageMessages(Random random) throws IOException, InterruptedException {
    Path file = folder.resolve("garbage.bin");
    for (String topic : GARBAGE_TOPICS) {
      Files.write(file, garbage(random));
      new ProcessBuilder(
              "mosquitto_pub", "-p", "" + broker.port(), "-t", topic, "-f", file.toString())
          .redirectErrorStream(true)
          .redirectOutput(ProcessBuilder.Redirect.DISCARD)
          .start()
          .waitFor();
    }
  }

  private void cutAircraft() throws IOException, InterruptedException {
    for (int port : List.of(vehicle.linesPort(), vehicle.controlsPort())) {
      new ProcessBuilder("ss", "-K", "sport", "=", ":" + port)
          .redirectErrorStream(true)
          .redirectOutput(ProcessBuilder.Redirect.DISCARD)
          .start()
          .waitFor();
    }
  }

  /** Lets time pass. */
  void pause(double seconds) throws InterruptedException {
    long until = clock.micros() + Clock.micros(seconds);
    while (clock.micros() < until) {
      waiter.await(until);
    }
  }
}
