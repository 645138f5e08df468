/**
 * Missions (thesis 3.2.3.2): their XML, the order of their goals, and the Mission Manager that
 * publishes the goals. Reaching goals belongs to planning.
 */
package org.u2sa.mission;
