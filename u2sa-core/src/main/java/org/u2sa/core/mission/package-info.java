/**
 * Missions (thesis 3.2.3.2): their XML, the order of their goals, and the Mission Manager that
 * hands goals out. How a goal is reached belongs to planning.
 */
package org.u2sa.core.mission;
