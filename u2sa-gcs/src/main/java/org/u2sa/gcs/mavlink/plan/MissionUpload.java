package org.u2sa.gcs.mavlink.plan;

import io.dronefleet.mavlink.common.MavMissionResult;
import io.dronefleet.mavlink.common.MavMissionType;
import io.dronefleet.mavlink.common.MissionItemInt;
import io.dronefleet.mavlink.common.MissionRequestInt;
import io.dronefleet.mavlink.util.EnumValue;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.u2sa.gcs.mavlink.station.GroundStation.Sender;

/** Fetches the items of an upload one by one. */
final class MissionUpload {
  /** Receives all items of an upload. */
  @FunctionalInterface
  interface Complete {
    void take(List<MissionItem> items, Sender from);
  }

  private static final int MAX_ITEMS = 1000;
  private static final long RETRY_MICROS = 400_000; // MAVSDK gives up after 2.5 s without a request
  private static final int MAX_RETRIES = 40;
  private static final int BACK =
      3; // items received before a request arrives, at a round trip of 0.2 s

  /** An upload under way. */
  private static final class Incoming {
    private final Sender from;
    private final int count;
    private final List<MissionItem> items = new ArrayList<>();
    private long askedMicros;
    private int retries;
    private int asked; // sequence number

    Incoming(Sender from, int count) {
      this.from = from;
      this.count = count;
    }

    boolean isLast(MissionItemInt item) {
      return item.seq() == count - 1;
    }
  }

  private final int type;
  private final String what;
  private final MissionAnswers answers;
  private final Complete complete;
  private Optional<Incoming> incoming = Optional.empty();
  private Optional<Incoming> finished = Optional.empty(); // the newest
  private long nowMicros;

  /**
   * @param type MAV_MISSION_TYPE
   * @param what name of the upload in texts
   */
  MissionUpload(int type, String what, MissionAnswers answers, Complete complete) {
    this.type = type;
    this.what = what;
    this.answers = answers;
    this.complete = complete;
  }

  /**
   * @param count number of items announced, at least one
   */
  void begin(int count, Sender from) {
    if (incoming.filter(other -> !other.from.equals(from)).isPresent()) {
      answers.acknowledge(MavMissionResult.MAV_MISSION_ERROR, type, from);
    } else if (count > MAX_ITEMS) {
      answers.refuse(
          MavMissionResult.MAV_MISSION_NO_SPACE,
          what + " of " + count + " items: expected at most " + MAX_ITEMS,
          type,
          from);
    } else {
      answers.forget(type);
      finished = Optional.empty();
      incoming = Optional.of(new Incoming(from, count));
      ask(incoming.get(), incoming.get().items.size());
    }
  }

  private void ask(Incoming upload, int seq) {
    upload.askedMicros = nowMicros;
    upload.asked = seq;
    answers
        .station()
        .send(
            MissionRequestInt.builder()
                .targetSystem(upload.from.system())
                .targetComponent(upload.from.component())
                .seq(seq)
                .missionType(EnumValue.create(MavMissionType.class, type))
                .build());
  }

  void take(MissionItemInt item, Sender from) {
    if (incoming.isEmpty() || !incoming.get().from.equals(from)) {
      if (finished.filter(upload -> upload.from.equals(from) && upload.isLast(item)).isPresent()) {
        answers.repeat(type, from); // MAVSDK repeats its last item if the acknowledgement is lost
      }
      return;
    }
    Incoming upload = incoming.get();
    if (item.seq() != upload.items.size()) {
      if (item.seq() == upload.asked) {
        ask(upload, upload.asked + 1);
      }
      return; // repeated: the requested item is on its way or will be requested again
    }
    upload.items.add(MissionItem.of(item));
    upload.retries = 0;
    if (upload.items.size() < upload.count) {
      ask(upload, upload.items.size());
    } else {
      incoming = Optional.empty();
      finished = Optional.of(upload);
      complete.take(upload.items, from);
    }
  }

  /**
   * Requests missing items again, then from an earlier item on: MAVSDK goes back when it receives a
   * late request, and then ignores requests beyond its next item.
   */
  void step(long micros) {
    nowMicros = micros;
    if (incoming.isEmpty() || micros - incoming.get().askedMicros < RETRY_MICROS) {
      return;
    }
    Incoming upload = incoming.get();
    if (upload.retries++ < MAX_RETRIES) {
      boolean isOdd = upload.retries % 2 == 1;
      int back = BACK * (upload.retries / 2) - (isOdd && upload.retries > 1 ? 1 : 0);
      ask(upload, Math.max(0, upload.items.size() - back)); // each item, and then the one after it
    } else {
      incoming = Optional.empty();
      answers.acknowledge(MavMissionResult.MAV_MISSION_OPERATION_CANCELLED, type, upload.from);
    }
  }
}
