/**
 * Messages that every service handles or sends regardless of its role: discovery, functionality,
 * configuration, health (thesis 3.2.2.1, 3.5.3), and the announcements of actuators. Stops and
 * failsafes are in {@link org.u2sa.messages.safety}, missions in {@link org.u2sa.messages.mission},
 * measurements and plans in {@link org.u2sa.messages}.
 */
package org.u2sa.messages.contract;
