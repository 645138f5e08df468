/**
 * Ways of vehicles that cannot turn tighter than a radius through grids of costs. Messages and
 * services do not belong here.
 */
package org.u2sa.core.planning.hybrid;
