/**
 * The messages that every service answers or sends whatever its role: discovery, functionality,
 * stop, configuration, health (thesis 3.2.2.1, 3.5.3) and the announcements and commands around
 * goals and actuators. What services measure, plan and command belongs in {@link
 * org.u2sa.messages}.
 */
package org.u2sa.messages.contract;
