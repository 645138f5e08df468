/** Access control: users, passwords and roles, and their files. Enforcement is up to the broker. */
package org.u2sa.core.security;
