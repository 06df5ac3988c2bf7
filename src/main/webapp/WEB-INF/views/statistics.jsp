<%@ page contentType="text/html;charset=UTF-8" session="false" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="root" value="${pageContext.request.contextPath}"/>
<fmt:message key="statistics.title" var="title"/>
<t:page title="${title}" here="statistics">
  <div class="heading">
    <div>
      <h1>${title}</h1>
      <p class="faint"><fmt:message key="statistics.basis"><fmt:param value="${statistics.looked}"/></fmt:message></p>
    </div>
  </div>
  <div class="figures">
    <article><p class="faint"><fmt:message key="statistics.doneToday"/></p><p class="figure"><fmt:formatNumber value="${statistics.doneToday}"/></p></article>
    <article>
      <p class="faint"><fmt:message key="statistics.mean"/></p>
      <p class="figure"><c:choose>
        <c:when test="${empty statistics.meanSeconds}"><small><fmt:message key="statistics.mean.none"/></small></c:when>
        <c:otherwise><fmt:formatNumber value="${statistics.meanSeconds}" maxFractionDigits="0" var="seconds"/><fmt:message key="statistics.seconds"><fmt:param value="${seconds}"/></fmt:message></c:otherwise>
      </c:choose></p>
    </article>
    <article><p class="faint"><fmt:message key="statistics.total"/></p><p class="figure"><fmt:formatNumber value="${count}"/></p></article>
  </div>
  <article>
    <h2><fmt:message key="statistics.byState"/></h2>
    <table class="bars">
      <tbody>
        <c:forEach items="${statistics.byState}" var="entry">
          <tr>
            <th scope="row"><t:state of="task" state="${entry.key}"/></th>
            <td class="bar"><progress value="${entry.value}" max="${statistics.looked == 0 ? 1 : statistics.looked}" aria-hidden="true"></progress></td>
            <td class="number"><fmt:formatNumber value="${entry.value}"/></td>
          </tr>
        </c:forEach>
      </tbody>
    </table>
  </article>
</t:page>
