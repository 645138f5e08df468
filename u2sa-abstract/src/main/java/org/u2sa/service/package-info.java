/**
 * The service itself (thesis 3.2.2, 8.2.3.1): U2SAService with its life, inbox and contract, and
 * the abstract sensors and actuators. Services that do something belong to other modules.
 */
package org.u2sa.service;
