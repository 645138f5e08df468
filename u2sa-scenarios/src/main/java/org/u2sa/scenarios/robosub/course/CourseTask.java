package org.u2sa.scenarios.robosub.course;

import java.util.List;
import org.u2sa.messages.ObjectDescription;

/** One task of a layout: its objects, its goals, and how it is judged. */
public interface CourseTask {
  /**
   * A goal of a mission file.
   *
   * @param element goal class, such as "passGate"
   * @param name unique in the mission
   * @param objectTypes types of the objects that it needs, in the order of the goal class
   */
  record Goal(String element, String name, List<String> objectTypes) {}

  /** Its objects, from {@link SubObjects}. */
  List<ObjectDescription> objects();

  /** Its goals, in order. */
  List<Goal> goals();

  /** A judge of one run. */
  SubTaskJudge judge();
}
