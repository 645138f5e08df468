/** Random fields of obstacles, dead ends and traffic, for every planner that sees. */
package org.u2sa.scenarios.fields;
