package org.u2sa.mission;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.u2sa.interfaces.xml.NearestNames;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.MessageTypes;

/** Goal classes of missions, by element name. */
final class GoalClasses {
  private final MessageTypes types;

  GoalClasses(MessageTypes types) {
    this.types = types;
  }

  /**
   * The goal class of an element.
   *
   * @throws org.u2sa.interfaces.BadInputException if there is none
   */
  MessageType<? extends GoalInformation> of(XmlElement element) {
    MessageType<?> type =
        types
            .byElementName(element.name())
            .orElseThrow(
                () ->
                    element.error(
                        "unknown element in <mission>; expected home or a class of goals: "
                            + String.join(", ", names())
                            + NearestNames.didYouMean(element.name(), names())));
    MessageType<? extends GoalInformation> goal = asGoal(type);
    if (goal == null) {
      throw element.error("is not a class of goals; expected one of " + String.join(", ", names()));
    }
    if (goal.isAbstract()) {
      throw element.error(
          "is abstract: no goal can be of this class; expected one of "
              + String.join(", ", names()));
    }
    return goal;
  }

  @SuppressWarnings("unchecked") // the message class was compared
  private static MessageType<? extends GoalInformation> asGoal(MessageType<?> type) {
    return GoalInformation.class.isAssignableFrom(type.messageClass())
        ? (MessageType<? extends GoalInformation>) type
        : null;
  }

  private List<String> names() {
    List<String> names = new ArrayList<>();
    for (MessageType<?> type : types.all()) {
      if (asGoal(type) != null && !type.isAbstract()) {
        names.add(type.name().substring(0, 1).toLowerCase(Locale.ROOT) + type.name().substring(1));
      }
    }
    return names;
  }
}
