package org.u2sa.messages.goal;

import java.util.List;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;

/**
 * Take-off of an aircraft, from a runway, a hand or in place; reached at the altitude {@link #z}.
 * An aeroplane keeps the direction {@link #psi} or, without it, its initial heading; a multirotor
 * rises vertically. x and y are ignored.
 */
public class TakeOff extends Waypoint {
  private static final Schema<TakeOff> SCHEMA =
      Schema.of(TakeOff.class, TakeOff::new, Waypoint.TYPE).since(3);

  public static final MessageType<TakeOff> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends TakeOff> type() {
    return TYPE;
  }

  @Override
  public TakeOff uid(String uid) {
    return (TakeOff) super.uid(uid);
  }

  @Override
  public TakeOff next(List<String> uids) {
    return (TakeOff) super.next(uids);
  }
}
